/** Messages between base and boat. */
package org.sami.boat.link;
