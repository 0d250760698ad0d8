package org.sami.crw.sim.run.record;

import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;

/** How deep boats may come into avoided areas, as announced to the operator in a run before they drive. From any thread. */
final class AnnouncedDepth implements Consumer<FleetEvent>, ReportFold {
    private OptionalDouble mostM = OptionalDouble.empty();

    @Override
    public synchronized void accept(FleetEvent event) {
        if (event instanceof FleetEvent.DepthAnnounced announced) {
            mostM = OptionalDouble.of(Math.max(mostM.orElse(0), announced.insideM()));
        }
    }

    @Override
    public synchronized void addTo(ReportDraft report) {
        report.announcedM(mostM);
    }
}
