package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.report.VesselsPart;
import org.sami.crw.report.VesselsPart.VesselApproach;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.crw.sim.vessel.VesselState;

/** Measures how near simulated boats truly come to foreign vessels, whatever anybody sees of them. For the run's thread. */
public final class VesselApproaches implements ReportFold {
    private final ForeignVessels vessels;
    private final Map<String, Map<String, VesselApproach>> nearest = new LinkedHashMap<>();

    /** Of these vessels. */
    public VesselApproaches(ForeignVessels vessels) {
        this.vessels = vessels;
    }

    /**
     * Records the true positions of boats and vessels; called often.
     *
     * @param states the vessels', in their order, on the plane of the boats' positions
     */
    public void look(long nowMillis, List<BoatState> boats, List<VesselState> states) {
        for (int i = 0; i < states.size(); i++) {
            String vessel = vessels.vessels().get(i).name();
            for (BoatState boat : boats) {
                double distanceM = states.get(i).distanceM(boat.eastM(), boat.northM());
                if (distanceM <= vessels.sightM()) {
                    nearest.computeIfAbsent(vessel, any -> new LinkedHashMap<>())
                            .merge(
                                    boat.id(),
                                    new VesselApproach(vessel, boat.id(), nowMillis / 1000.0, distanceM),
                                    (before, now) -> now.distanceM() < before.distanceM() ? now : before);
                }
            }
        }
    }

    /** The nearest approaches so far, by vessel and boat. */
    public List<VesselApproach> approaches() {
        List<VesselApproach> all = new ArrayList<>();
        nearest.values().forEach(ofVessel -> all.addAll(ofVessel.values()));
        return all;
    }

    @Override
    public void addTo(ReportDraft report) {
        report.add(new VesselsPart(approaches()));
    }
}
