package org.sami.crw.report;

import java.util.List;
import java.util.Locale;

/**
 * How near boats truly came to vessels that are not of the base.
 *
 * @param approaches the nearest of each vessel and boat that came within sight of each other, by vessel
 */
public record VesselsPart(List<VesselApproach> approaches) implements ReportPart {
    public VesselsPart {
        approaches = List.copyOf(approaches);
    }

    /**
     * The nearest approach of a boat to a vessel.
     *
     * @param atSeconds when, in simulated seconds
     * @param distanceM of the boat's position to the vessel's hull, in metres
     */
    public record VesselApproach(String vessel, String boat, double atSeconds, double distanceM) {}

    @Override
    public String name() {
        return "vessels";
    }

    @Override
    public List<?> json() {
        return approaches;
    }

    /** A line for each vessel, with the boat that came nearest. */
    @Override
    public List<String> lines() {
        return approaches.stream()
                .map(VesselApproach::vessel)
                .distinct()
                .map(vessel -> approaches.stream()
                        .filter(one -> one.vessel().equals(vessel))
                        .min((one, other) -> Double.compare(one.distanceM(), other.distanceM()))
                        .orElseThrow())
                .map(one -> String.format(
                        Locale.ROOT,
                        "%-11s nearest %s, %.1f m at %.0f s",
                        one.vessel(),
                        one.boat(),
                        one.distanceM(),
                        one.atSeconds()))
                .toList();
    }

    @Override
    public List<String> columns() {
        return List.of("vessel", "boat", "at_s", "distance_m");
    }

    @Override
    public List<List<Object>> rows() {
        return approaches.stream()
                .map(one -> List.<Object>of(one.vessel(), one.boat(), one.atSeconds(), one.distanceM()))
                .toList();
    }
}
