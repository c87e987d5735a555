#pragma once

#include "parameters/Parameters.hpp"

#include <Teuchos_ParameterEntryValidator.hpp>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace asperity
{
struct TableFunctions;

enum class ParameterKind
{
  real,
  integer,
  boolean,
  text,
  file_name,
  choice,
  field,
  real_array,
  integer_array,
  text_array,
  sublist,
  open_sublist,
  foreign_sublist,
  alternative // entries that the list itself has with one word of a choice
};

enum class Presence
{
  has_default,
  is_required,
  is_optional
};

// What a declaration says in addition to default and meaning. It is the validator of the entry, so
// that ParameterList::set also refuses wrong types and values out of range.
class ParameterInfo : public Teuchos::ParameterEntryValidator
{
public:
  ParameterKind kind = ParameterKind::real;
  Presence presence = Presence::has_default;
  std::string unit = "-";
  Range range = Range::any();
  std::vector<std::string> words; // of a choice; the one word of an alternative
  std::string chosen_by;          // of a list or alternative: the choice that decides, or ""
  std::string hint;
  bool takes_datasets = true; // of a field
  // Of a field in a deck: the functions that its expressions may call, or null.
  std::shared_ptr<const TableFunctions> tables;

  bool isDimensionless() const { return unit.empty() || unit == "-"; }

  // "a number in (0, inf) m", "one of 'Ageing', 'Slip'"
  std::string allowed() const;

  // InputError "<path> = <value> is ... <hint>" unless type and value are allowed. Numbers inside
  // an open or foreign list are not checked.
  void check(Teuchos::ParameterEntry const& entry, std::string const& path) const;

  // Converts int to double, and arrays of int to arrays of double, where the declaration says so.
  void convert(Teuchos::ParameterEntry& entry) const;

  const std::string getXMLTypeName() const override { return "asperity::ParameterInfo"; }
  void printDoc(std::string const& meaning, std::ostream& out) const override;
  ValidStringsList validStringValues() const override;
  void validate(Teuchos::ParameterEntry const& entry, std::string const& name,
                std::string const& list_name) const override;

private:
  std::string rangeText() const; // with the unit
  void checkRange(double value, std::string const& path) const;
  void checkRegions(ParameterList const& regions, std::string const& path) const;
  void checkArray(Teuchos::ParameterEntry const& entry, std::string const& path) const;
  [[noreturn]] void refuse(std::string const& path, std::string const& value,
                           std::string const& reason) const;
};

// The information of a declared or completed entry; null if it has none.
Teuchos::RCP<const ParameterInfo> parameterInfo(Teuchos::ParameterEntry const& entry);
Teuchos::RCP<const ParameterInfo> parameterInfo(ParameterList const& list, std::string const& name);
} // namespace asperity
