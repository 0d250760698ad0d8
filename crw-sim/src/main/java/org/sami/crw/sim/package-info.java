/** The simulation of boats and water. */
package org.sami.crw.sim;
