/** The plans of the second domain, aircraft, as data. */
package org.sami.domain.uav;
