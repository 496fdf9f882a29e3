// What planners were compared on: grid maps, or fields.
export const placesOf = (comparison) => comparison.fields ?? comparison.maps;

// Of a result or a run: the name of the map or field it is of.
export const placeOf = (entry) => entry.field ?? entry.map;

export function placeWord(comparison, count) {
  const word = comparison.fields ? 'field' : 'map';
  return count === 1 ? word : `${word}s`;
}
