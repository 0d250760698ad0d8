/**
 * The screens on the phone, for wet hands in the sun: how the boat is, its settings, the check of its motors.
 *
 * <p>Not here: the boat, which goes on without them.
 */
package org.sami.boat.app.screen;
