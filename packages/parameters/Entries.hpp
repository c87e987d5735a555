#pragma once

#include "base/Errors.hpp"
#include "parameters/Parameters.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity
{
// Declares the entries of a list, and reads them into the members of a struct: one call for each
// entry names both, so that nothing is read under another name, or not at all.
//
//   Entries<Wedge> entries()
//   {
//     return Entries<Wedge>()
//       .real("Length", &Wedge::length, "m", Range::positive(), "The surface has this length.")
//       .choice("Cells", &Wedge::cells, {{"Graded", Cells::graded}, {"Layers", Cells::layers}},
//               "Selects how the wedge is divided.");
//   }
//   entries().list();           // for completeAndValidate
//   entries().read(list, path); // a Wedge
//
// The default of an entry is what its member has in the struct given to the constructor; `required`
// before the unit or meaning says that the deck has to give the entry. A member is a pointer to
// member or any function that returns a reference to the value, for members of members:
// [](Wedge& wedge) -> int& { return wedge.base.num_cells; }.
template <class T>
class Entries
{
public:
  explicit Entries(T defaults = {}) : defaults_(std::move(defaults)) {}
  // The entries join those of a list that must outlive this object.
  Entries(T defaults, ParameterList& list) : defaults_(std::move(defaults)), declare_(list) {}

  template <class Member>
  Entries& real(std::string const& name, Member member, std::string const& unit, Range range,
                std::string const& meaning)
  {
    declare_.real(name, value(member), unit, range, meaning);
    return bind<double>(name, member);
  }
  template <class Member>
  Entries& real(std::string const& name, Member member, Required, std::string const& unit,
                Range range, std::string const& meaning)
  {
    declare_.real(name, required, unit, range, meaning);
    return bind<double>(name, member);
  }
  // An entry that the deck may leave out; the member is a std::optional<double>.
  template <class Member>
  Entries& real(std::string const& name, Member member, Optional, std::string const& unit,
                Range range, std::string const& meaning)
  {
    declare_.real(name, optional, unit, range, meaning);
    readers_.push_back([=](ParameterList const& list, std::string const&, T& result) {
      if (list.isParameter(name)) {
        std::invoke(member, result) = list.get<double>(name);
      }
    });
    return *this;
  }
  template <class Member>
  Entries& integer(std::string const& name, Member member, Range range, std::string const& meaning)
  {
    declare_.integer(name, value(member), range, meaning);
    return bind<int>(name, member);
  }
  template <class Member>
  Entries& boolean(std::string const& name, Member member, std::string const& meaning)
  {
    declare_.boolean(name, value(member), meaning);
    return bind<bool>(name, member);
  }
  template <class Member>
  Entries& text(std::string const& name, Member member, std::string const& meaning)
  {
    declare_.text(name, value(member), meaning);
    return bind<std::string>(name, member);
  }
  template <class Member>
  Entries& text(std::string const& name, Member member, Required, std::string const& meaning)
  {
    declare_.text(name, required, meaning);
    return bind<std::string>(name, member);
  }
  template <class Member>
  Entries& fileName(std::string const& name, Member member, Required, std::string const& meaning)
  {
    declare_.fileName(name, required, meaning);
    return bind<std::string>(name, member);
  }
  template <class Member>
  Entries& fileName(std::string const& name, Member member, std::string const& meaning)
  {
    declare_.fileName(name, value(member), meaning);
    return bind<std::string>(name, member);
  }

  // Words and the values that they stand for.
  template <class Value>
  using Words = std::vector<std::pair<std::string, Value>>;
  template <class Member>
  using ValueOf = std::decay_t<std::invoke_result_t<Member&, T&>>;

  template <class Member>
  Entries& choice(std::string const& name, Member member, Words<ValueOf<Member>> const& words,
                  std::string const& meaning)
  {
    std::vector<std::string> names;
    std::string chosen;
    for (auto const& [word, of_word] : words) {
      names.push_back(word);
      if (chosen.empty() && of_word == value(member)) {
        chosen = word;
      }
    }
    declare_.choice(name, chosen, names, meaning);
    readers_.push_back([=](ParameterList const& list, std::string const&, T& result) {
      auto const& given = list.get<std::string>(name);
      std::invoke(member, result) = std::find_if(words.begin(), words.end(), [&](auto const& word) {
                                      return word.first == given;
                                    })->second;
    });
    return *this;
  }
  // The member is the chosen word, as for names of a registry.
  template <class Member>
  Entries& choiceOfWords(std::string const& name, Member member,
                         std::vector<std::string> const& words, std::string const& meaning)
  {
    declare_.choice(name, value(member), words, meaning);
    return bind<std::string>(name, member);
  }
  template <class Member>
  Entries& choiceOfWords(std::string const& name, Member member, Required,
                         std::vector<std::string> const& words, std::string const& meaning)
  {
    declare_.choice(name, required, words, meaning);
    return bind<std::string>(name, member);
  }

  // The member is the chosen word.
  template <class Member>
  Entries& choiceOfLists(std::string const& name, Member member,
                         std::vector<Declare::NamedList> const& lists, std::string const& meaning)
  {
    declare_.choiceOfLists(name, value(member), lists, meaning);
    return bind<std::string>(name, member);
  }

  // A vector of any length, or an std::array, whose length the deck has to keep.
  template <class Member>
  Entries& realArray(std::string const& name, Member member, std::string const& unit, Range range,
                     std::string const& meaning)
  {
    auto const defaults = value(member);
    declare_.realArray(name, std::vector<double>(defaults.begin(), defaults.end()), unit, range,
                       meaning);
    readers_.push_back([=](ParameterList const& list, std::string const& path, T& result) {
      auto const& given = list.get<Teuchos::Array<double>>(name);
      auto& values = std::invoke(member, result);
      if constexpr (std::is_same_v<ValueOf<Member>, std::vector<double>>) {
        values = given.toVector();
      } else {
        ASPERITY_REQUIRE(given.size() == static_cast<int>(values.size()),
                         joinPath(path, name) << " has " << given.size() << " numbers, but needs "
                                              << values.size() << ".");
        std::copy(given.begin(), given.end(), values.begin());
      }
    });
    return *this;
  }

  // An entry that the deck may leave out; the member is a std::optional<std::vector<double>>.
  template <class Member>
  Entries& realArray(std::string const& name, Member member, Optional, std::string const& unit,
                     Range range, std::string const& meaning)
  {
    declare_.realArray(name, optional, unit, range, meaning);
    readers_.push_back([=](ParameterList const& list, std::string const&, T& result) {
      if (list.isParameter(name)) {
        std::invoke(member, result) = list.get<Teuchos::Array<double>>(name).toVector();
      }
    });
    return *this;
  }
  template <class Member>
  Entries& realArray(std::string const& name, Member member, Required, std::string const& unit,
                     Range range, std::string const& meaning)
  {
    declare_.realArray(name, required, unit, range, meaning);
    return bindVector<double>(name, member);
  }
  template <class Member>
  Entries& integerArray(std::string const& name, Member member, Range range,
                        std::string const& meaning)
  {
    declare_.integerArray(name, value(member), range, meaning);
    return bindVector<int>(name, member);
  }
  template <class Member>
  Entries& textArray(std::string const& name, Member member, std::string const& meaning)
  {
    declare_.textArray(name, value(member), meaning);
    return bindVector<std::string>(name, member);
  }

  // An entry that the deck may leave out; the member is a std::optional<std::vector<std::string>>.
  template <class Member>
  Entries& textArray(std::string const& name, Member member, Optional, std::string const& meaning)
  {
    declare_.textArray(name, optional, meaning);
    readers_.push_back([=](ParameterList const& list, std::string const&, T& result) {
      if (list.isParameter(name)) {
        std::invoke(member, result) = list.get<Teuchos::Array<std::string>>(name).toVector();
      }
    });
    return *this;
  }

  Entries& hint(std::string const& text)
  {
    declare_.hint(text);
    return *this;
  }

  // Entries that are no members, as fields, are declared here and read by hand.
  Declare& others() { return declare_; }

  Teuchos::RCP<ParameterList> list() const { return declare_.list(); }

  // list: complete, see completeAndValidate; path: where it stands, for messages of InputError.
  T read(ParameterList const& list, std::string const& path) const
  {
    T result = defaults_;
    for (auto const& reader : readers_) {
      reader(list, path, result);
    }
    return result;
  }

private:
  template <class Member>
  ValueOf<Member> value(Member member)
  {
    return std::invoke(member, defaults_);
  }

  // Stored: the type of the value in the list.
  template <class Stored, class Member>
  Entries& bind(std::string const& name, Member member)
  {
    readers_.push_back([=](ParameterList const& list, std::string const&, T& result) {
      std::invoke(member, result) = list.get<Stored>(name);
    });
    return *this;
  }

  template <class Stored, class Member>
  Entries& bindVector(std::string const& name, Member member)
  {
    readers_.push_back([=](ParameterList const& list, std::string const&, T& result) {
      std::invoke(member, result) = list.get<Teuchos::Array<Stored>>(name).toVector();
    });
    return *this;
  }

  T defaults_;
  Declare declare_;
  std::vector<std::function<void(ParameterList const&, std::string const& path, T&)>> readers_;
};
} // namespace asperity
