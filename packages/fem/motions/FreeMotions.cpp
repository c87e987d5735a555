#include "fem/motions/FreeMotions.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/motions/BodyPieces.hpp"

#include <Teuchos_LAPACK.hpp>
#include <Tpetra_MultiVector.hpp>

#include <cmath>
#include <sstream>

namespace asperity::fem
{
namespace
{
// An eigenvalue of G below this share of its trace counts as zero. Rounding stays below it; held
// dofs exceed it even if they lie on a small part of the body.
constexpr double smallest_eigenvalue = 1e-12;

// The eigenvalues of a symmetric matrix (size, size), ascending, and the eigenvectors.
struct Eigensystem
{
  int size;
  std::vector<double> vectors; // (size, size), one after the other
  std::vector<double> values;

  double entry(int of_vector, int component) const { return vectors[of_vector * size + component]; }
};

Eigensystem decompose(int size, std::vector<double> const& matrix)
{
  Eigensystem result{size, matrix, std::vector<double>(size)};
  std::vector<double> work(10 * size + 10);
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', size, result.vectors.data(), size,
                                      result.values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  ASPERITY_ASSERT(info == 0);
  return result;
}

// "x", or "(0.6, 0.8)"; the first component that is not zero is positive.
std::string directionText(std::vector<double> direction)
{
  double sign = 0;
  for (double& component : direction) {
    component = std::round(1000 * component) / 1000;
    sign = sign != 0 || component == 0 ? sign : component < 0 ? -1 : 1;
  }
  std::ostringstream text;
  for (std::size_t c = 0; c < direction.size(); ++c) {
    const double component = direction[c] == 0 ? 0 : sign * direction[c];
    if (component == 1) {
      return std::string(1, "xyz"[c]);
    }
    text << (c == 0 ? "(" : ", ") << component;
  }
  return text.str() + ")";
}

// The translations among the combinations of motions in `free`, orthonormal vectors.
std::vector<std::vector<double>> translationsIn(std::vector<std::vector<double>> const& free,
                                                int components)
{
  std::vector<double> projector(components * components, 0.);
  for (auto const& vector : free) {
    for (int i = 0; i < components; ++i) {
      for (int j = 0; j < components; ++j) {
        projector[i * components + j] += vector[i] * vector[j];
      }
    }
  }
  auto const eigen = decompose(components, projector);
  std::vector<std::vector<double>> found;
  for (int k = 0; k < components; ++k) {
    if (eigen.values[k] > 1 - 1e-8) {
      found.emplace_back();
      for (int c = 0; c < components; ++c) {
        found.back().push_back(eigen.entry(k, c));
      }
    }
  }
  return found;
}

// The axis about which a body in three dimensions turns. Entries 3 to 5 of a vector in `free` are
// rotations in the planes xy, xz and yz.
std::vector<double> axisOf(std::vector<std::vector<double>> const& free)
{
  std::vector<double> squares(9, 0.);
  for (auto const& vector : free) {
    const std::vector<double> axis = {vector[5], -vector[4], vector[3]};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        squares[3 * i + j] += axis[i] * axis[j];
      }
    }
  }
  auto const eigen = decompose(3, squares);
  return {eigen.entry(2, 0), eigen.entry(2, 1), eigen.entry(2, 2)};
}

template <int Dim>
std::string inWords(std::vector<std::vector<double>> const& free, int components)
{
  if (components == 1) {
    return "along z";
  }
  auto const translations = translationsIn(free, components);
  std::string text;
  if (static_cast<int>(translations.size()) == components) {
    text = "in every direction";
  } else {
    for (auto const& direction : translations) {
      text += (text.empty() ? "along " : " and along ") + directionText(direction);
    }
  }
  const std::size_t num_turns = free.size() - translations.size();
  if (num_turns == 0) {
    return text;
  }
  text += text.empty() ? "" : " and ";
  if (Dim == 2) {
    return text + "by turning in its plane about a point";
  }
  const bool has_all_axes = free.front().size() == 6;
  return text + (num_turns > 1  ? "by turning about more than one axis"
                 : has_all_axes ? "by turning about an axis along " + directionText(axisOf(free))
                                : "by turning about the axis of its period");
}

// The combinations of motions that vanish at all resisting dofs: the null vectors of G.
std::vector<std::vector<double>> nullVectors(int size, std::vector<double> const& gram)
{
  auto const eigen = decompose(size, gram);
  double trace = 0;
  for (const double value : eigen.values) {
    trace += value;
  }
  std::vector<std::vector<double>> found;
  for (int k = 0; k < size && eigen.values[k] <= smallest_eigenvalue * trace; ++k) {
    auto const begin = eigen.vectors.begin() + k * size;
    found.emplace_back(begin, begin + size);
  }
  return found;
}

// The matrix G of one piece, summed over all ranks.
template <class IsOfPiece>
std::vector<double> gramOf(MultiVector const& motions, std::vector<int> const& resisting,
                           int components, IsOfPiece const& is_of_piece,
                           Communicator const& communicator)
{
  const int size = static_cast<int>(motions.getNumVectors());
  std::vector<double> gram(size * size, 0.);
  auto const values = motions.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t dof = 0; dof < resisting.size(); ++dof) {
    if (resisting[dof] != 0 && is_of_piece(static_cast<int>(dof) / components)) {
      for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
          gram[i * size + j] += values(dof, i) * values(dof, j);
        }
      }
    }
  }
  return sumOverRanks(gram, communicator);
}
} // namespace

template <int Dim>
std::vector<std::string> freeMotions(Mesh<Dim> const& mesh, int components,
                                     MultiVector const& motions, std::vector<int> const& resisting,
                                     RCP<const Communicator> const& communicator)
{
  const int size = static_cast<int>(motions.getNumVectors());
  auto const pieces = bodyPieces(mesh, communicator);
  const bool is_one = pieces.num_pieces == 1 || pieces.num_pinched > 0;
  std::vector<std::string> found;
  GlobalOrdinal piece = -1;
  for (GlobalOrdinal k = 0; k < (is_one ? 1 : pieces.num_pieces); ++k) {
    piece = pieces.nextPiece(piece, *communicator);
    auto const gram = gramOf(
      motions, resisting, components,
      [&](int node) { return is_one || pieces.labels[node] == piece; }, *communicator);
    auto const free = nullVectors(size, gram);
    if (!free.empty()) {
      found.push_back(inWords<Dim>(free, components) +
                      (is_one ? "" : " (the piece with vertex " + std::to_string(piece) + ")"));
    }
  }
  return found;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<std::string> freeMotions(Mesh<Dim> const&, int, MultiVector const&,         \
                                                std::vector<int> const&,                           \
                                                RCP<const Communicator> const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
