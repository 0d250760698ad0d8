/** Plans of teams of boats and copters, from their start to their end on simulated robots. */
package org.sami.uav.team;
