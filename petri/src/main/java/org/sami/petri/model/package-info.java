/**
 * Well-known nets of any size, for measurements, tests and first steps.
 *
 * <p>Not here: nets of plans.
 */
@NullMarked
package org.sami.petri.model;

import org.jspecify.annotations.NullMarked;
