/**
 * What sensors measured over an area, as a grid of values with its legend and its lines of equal value.
 *
 * <p>Belongs here: pure computations on samples. Does not belong here: which sensor is shown and why ({@code org.sami.crw.operator}), and
 * how anything is painted.
 */
@NullMarked
package org.sami.crw.service.field;

import org.jspecify.annotations.NullMarked;
