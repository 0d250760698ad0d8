package org.sami.crw.gui.station;

import java.awt.Component;
import java.util.Optional;
import org.sami.crw.cli.station.StationLinks;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The sheet with which the session's simulated boats are shown to a ground station. On the event thread. */
public final class StationShow {
    private final OperatorContext context;
    private final Component inside;
    private Optional<StationLinks> links = Optional.empty();

    /** A sheet of the window in which a component lies. */
    public StationShow(OperatorContext context, Component inside) {
        this.context = context;
        this.inside = inside;
    }

    /** Says which simulated robots there are; only boats can be shown. */
    public void of(SimulatedBoatsOnTcp boats) {
        links = boats.robots() == RobotKind.BOAT ? Optional.of(new StationLinks(boats)) : Optional.empty();
    }

    /** Why nothing can be shown; empty where something can. */
    public Optional<String> whyNot() {
        return links.isPresent() ? Optional.empty() : Optional.of("this window has no simulated boats");
    }

    /** Opens the sheet. */
    public void open() {
        links.ifPresent(shown -> WindowSheet.in(inside)
                .open(new Sheet(
                        "boats-ground-station-sheet",
                        "Show simulated boats to a ground station",
                        new StationForm(context, shown))));
    }

    /** Ends what is shown; with the window. */
    public void close() {
        links.ifPresent(StationLinks::stop);
    }
}
