/** When missions were in the phases of their plans, and their robots at its places: the bars of a Gantt chart, and how they follow from the engine's effects. */
@NullMarked
package org.sami.crw.operator.gantt;

import org.jspecify.annotations.NullMarked;
