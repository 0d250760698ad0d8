package org.sami.crw.sim.fleet;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;

/**
 * One line of a simulated boat's own log.
 *
 * @param timeMs virtual time
 * @param commandId the id under which it came
 * @param answer what the boat answered, an acknowledgement or a refusal
 */
public record ExecutedCommand(long timeMs, String commandId, CommandMessage command, LinkMessage answer) {}
