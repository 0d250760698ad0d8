package org.sami.crw.proxy.status;

import org.sami.boat.link.BatteryLevel;

/**
 * What a boat said of its battery.
 *
 * @param percent charge in percent of full
 * @param level the class that the boat puts it in
 */
public record BatteryState(double percent, BatteryLevel level) {}
