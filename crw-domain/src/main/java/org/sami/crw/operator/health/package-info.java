/**
 * Faults that last, as the operator, the console, {@code crw run} and reports read them: what is wrong, since when, whom it concerns and what to do. Does not
 * belong here: what finds a fault (the session, the fleet, the checks of {@code org.sami.crw.operator.alarm}).
 */
package org.sami.crw.operator.health;
