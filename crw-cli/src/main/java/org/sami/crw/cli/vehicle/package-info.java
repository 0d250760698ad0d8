/** The command that lists vehicles of other makers, which speak MAVLink, and its words. */
package org.sami.crw.cli.vehicle;
