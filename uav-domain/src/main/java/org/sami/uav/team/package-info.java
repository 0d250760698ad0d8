/**
 * What plans ask of teams in which copters and boats are together: which robots can do something. What one kind of robots is asked does not belong here.
 */
@NullMarked
package org.sami.uav.team;

import org.jspecify.annotations.NullMarked;
