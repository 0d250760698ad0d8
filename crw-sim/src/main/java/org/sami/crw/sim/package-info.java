/** The simulation of boats and water. */
@NullMarked
package org.sami.crw.sim;

import org.jspecify.annotations.NullMarked;
