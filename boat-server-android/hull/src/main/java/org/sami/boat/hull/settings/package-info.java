/**
 * What is set for one hull and kept in a file, and the guided check of its motors that finds it out.
 *
 * <p>Not here: settings of the boat server.
 */
package org.sami.boat.hull.settings;
