/**
 * What an automatic change of a view may do while a person works there (meta-markup, thesis 5.3).
 *
 * <p>Belongs here: the decision whether, and when, such a change is made. Does not belong here: the changes themselves; whoever makes them
 * asks first.
 */
@NullMarked
package org.sami.crw.manipulation;

import org.jspecify.annotations.NullMarked;
