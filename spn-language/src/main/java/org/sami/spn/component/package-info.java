/**
 * Chooses with which components a window shows or asks for values (thesis 5.2.4, Algorithms 4, 5 and 6).
 *
 * <p>Belongs here: what components and widgets of a domain say they can do, what an interaction needs, and the choice. Does not
 * belong here: the components themselves, which are windows' classes of the same names.
 */
@NullMarked
package org.sami.spn.component;

import org.jspecify.annotations.NullMarked;
