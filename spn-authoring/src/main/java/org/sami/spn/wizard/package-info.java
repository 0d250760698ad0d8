/**
 * Helps authors to write nets: what comes with an event that is added (thesis 5.1.1, Event Wizard), which requirements edges then need, and
 * what can come next at a vertex. All of it is edits and answers about plans; what belongs to which event is data of the domain
 * ({@link org.sami.spn.sequence.AuthoringLibrary}). No window.
 */
@NullMarked
package org.sami.spn.wizard;

import org.jspecify.annotations.NullMarked;
