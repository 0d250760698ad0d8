/** The Gantt chart: the missions over time, with their phases and robots, and what of it is in sight. */
@NullMarked
package org.sami.crw.gui.gantt;

import org.jspecify.annotations.NullMarked;
