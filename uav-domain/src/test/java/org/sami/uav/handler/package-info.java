/** Tests of the aircraft domain, on the simulated copters of crw-sim. */
package org.sami.uav.handler;
