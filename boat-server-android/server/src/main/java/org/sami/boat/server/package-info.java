/** The boat server. */
package org.sami.boat.server;
