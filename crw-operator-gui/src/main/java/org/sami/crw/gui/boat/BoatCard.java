package org.sami.crw.gui.boat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.palette.SemanticColor;

/**
 * What a card says of a boat.
 *
 * @param name of the boat, or the address that does not answer
 * @param known whether it is a boat that is known, and has a mark
 * @param state what it does, or why it does not move
 * @param trouble the colour of the state
 * @param battery its charge, in its colour
 * @param figures other numbers, in the order of their weight
 * @param link the age of its last word
 */
record BoatCard(
        String name,
        boolean known,
        String state,
        SemanticColor trouble,
        String battery,
        SemanticColor charge,
        List<String> figures,
        String link,
        boolean stale) {
    /** The card of a boat as it is known now. */
    static BoatCard of(OperatorContext context, BoatSnapshot boat, String link, boolean stale) {
        List<String> figures = new ArrayList<>();
        if (context.kindOf(boat.boat()) == RobotKind.COPTER) {
            figures.add(BoatWords.altitude(boat));
        }
        figures.add(BoatWords.speed(boat));
        Optional.of(boat).filter(one -> one.points() > 0).ifPresent(one -> figures.add("path " + BoatWords.path(one)));
        return new BoatCard(
                boat.boat(),
                context.models().fleet().boat(boat.boat()).isPresent(),
                context.sayOf(boat.boat(), BoatWords.brief(boat)),
                BoatWords.color(BoatWords.trouble(boat)),
                BoatWords.battery(boat),
                batteryColor(boat, stale),
                figures,
                link,
                stale);
    }

    /** The colour of a charge. */
    static SemanticColor batteryColor(BoatSnapshot boat, boolean stale) {
        return boat.battery()
                .map(battery -> switch (battery.level()) {
                    case NOMINAL -> stale ? SemanticColor.STALE : SemanticColor.TEXT;
                    case LOW -> SemanticColor.WARNING;
                    case CRITICAL -> SemanticColor.CRITICAL;
                })
                .orElse(SemanticColor.MUTED);
    }
}
