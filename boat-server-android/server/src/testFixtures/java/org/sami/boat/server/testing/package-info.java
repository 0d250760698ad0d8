/** What tests of boats over sockets and processes share, in the modules of the boats and of those who command them. */
package org.sami.boat.server.testing;
