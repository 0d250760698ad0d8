/**
 * Lasting faults for the operator, the console, {@code crw run} and reports: the fault, its beginning, its subject and its remedy. Not here: finding
 * faults (the session, the fleet, the checks of {@code org.sami.crw.operator.alarm}).
 */
@NullMarked
package org.sami.crw.operator.health;

import org.jspecify.annotations.NullMarked;
