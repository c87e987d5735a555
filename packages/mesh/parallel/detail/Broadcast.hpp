#pragma once

#include "base/Types.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <array>
#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// Sends the data of rank 0 to all other ranks.
class Broadcast
{
public:
  explicit Broadcast(Communicator const& communicator) : communicator_(communicator) {}

  int size(std::size_t mine) const
  {
    auto size = static_cast<int>(mine);
    Teuchos::broadcast(communicator_, 0, &size);
    return size;
  }

  template <class Number>
  void values(std::vector<Number>& values) const
  {
    values.resize(static_cast<std::size_t>(size(values.size())));
    Teuchos::broadcast(communicator_, 0, static_cast<int>(values.size()), values.data());
  }

  template <class Number, std::size_t N>
  void rows(std::vector<std::array<Number, N>>& rows) const
  {
    rows.resize(static_cast<std::size_t>(size(rows.size())));
    std::vector<Number> column(rows.size());
    for (std::size_t n = 0; n < N; ++n) {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        column[i] = rows[i][n];
      }
      Teuchos::broadcast(communicator_, 0, static_cast<int>(column.size()), column.data());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i][n] = column[i];
      }
    }
  }

  void text(std::string& text) const
  {
    std::vector<char> letters(text.begin(), text.end());
    values(letters);
    text.assign(letters.begin(), letters.end());
  }

  void texts(std::vector<std::string>& texts) const
  {
    texts.resize(static_cast<std::size_t>(size(texts.size())));
    for (auto& one : texts) {
      text(one);
    }
  }

private:
  Communicator const& communicator_;
};
} // namespace asperity::mesh::detail
