/** The files that a boat keeps and gives to its clients in pieces: its log and what else the boat's host names. */
package org.sami.boat.server.file;
