/**
 * Values and their types: the typed trees that event fields, variables and markups hold.
 *
 * <p>Belongs here: immutable values, their types, the test whether a value is of a type. Does not belong here: JSON
 * (see {@code spn.json}), anything that interprets a value for one domain.
 */
@NullMarked
package org.sami.spn.value;

import org.jspecify.annotations.NullMarked;
