/**
 * Suggests requirements at an edge (thesis 4.3.3, 5.1.1): makes those that the language allows there, judges each by the checks and by deep
 * checks with several teams, and says what each would change.
 *
 * <p>Belongs here: the candidates, their judgement and their order. Does not belong here: requirements computed from the plan's events alone,
 * which need no search ({@code spn.wizard}), and the searches themselves ({@code spn.statespace}).
 *
 * <p>{@link org.sami.spn.suggestion.EdgeSuggestions} is where to begin.
 */
@NullMarked
package org.sami.spn.suggestion;

import org.jspecify.annotations.NullMarked;
