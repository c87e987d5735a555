#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <TpetraCore_config.h>
#include <Tpetra_CrsGraph_fwd.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_Export_fwd.hpp>
#include <Tpetra_Import_fwd.hpp>
#include <Tpetra_Map_fwd.hpp>
#include <Tpetra_MultiVector_fwd.hpp>
#include <Tpetra_Vector_fwd.hpp>

// The one place that fixes Tpetra's template arguments: double, 32-bit local ids, and 64-bit global
// ids where Trilinos has them.
namespace asperity
{
using Teuchos::RCP;
using Teuchos::rcp;

using Communicator = Teuchos::Comm<int>;
using LocalOrdinal = int;
#ifdef HAVE_TPETRA_INST_INT_LONG_LONG
using GlobalOrdinal = long long;
#else
using GlobalOrdinal = int; // such a build refuses models with 2^31 unknowns and more
#endif

using Map = Tpetra::Map<LocalOrdinal, GlobalOrdinal>;
using Import = Tpetra::Import<LocalOrdinal, GlobalOrdinal>;
using Export = Tpetra::Export<LocalOrdinal, GlobalOrdinal>;
using Vector = Tpetra::Vector<double, LocalOrdinal, GlobalOrdinal>;
using MultiVector = Tpetra::MultiVector<double, LocalOrdinal, GlobalOrdinal>;
using CrsGraph = Tpetra::CrsGraph<LocalOrdinal, GlobalOrdinal>;
using CrsMatrix = Tpetra::CrsMatrix<double, LocalOrdinal, GlobalOrdinal>;
} // namespace asperity
