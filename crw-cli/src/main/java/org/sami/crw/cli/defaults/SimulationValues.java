package org.sami.crw.cli.defaults;

import java.util.List;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.vessel.ForeignVessels;

/** The numbers of simulated water and of the boats on it that no option names by itself. */
final class SimulationValues {
    private SimulationValues() {}

    static List<DefaultValue> all() {
        return new SubjectDefaults("Simulated boats")
                .number(
                        "battery",
                        Energy.USUAL_BATTERY_WH,
                        "Wh",
                        "Energy of a full battery of simulated boats, where they use it by their speed.",
                        "--energy battery=WH")
                .number(
                        "sight",
                        ForeignVessels.USUAL_SIGHT_M,
                        "m",
                        "Simulated boats see other vessels up to this distance.",
                        "\"sight\" of the file of --vessels")
                .values();
    }
}
