package org.sami.ui.value;

import java.util.List;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/** What can be chosen by name where an editor is, as far as no question offers less. Asked whenever an editor is made. */
public interface NamedThings {
    /** Nothing is known. */
    NamedThings NONE = new NamedThings() {};

    /** Robots, as values of type proxy. */
    default List<ChoiceRow> proxies() {
        return List.of();
    }

    /** Whether robots can be named that are not known here, as in a plan that is written before they are met. */
    default boolean takesOtherRobots() {
        return false;
    }

    /** Tasks, as values of type task. */
    default List<ChoiceRow> tasks() {
        return List.of();
    }

    /** Variables, as values of type variable. */
    default List<ChoiceRow> variables() {
        return List.of();
    }

    /** Plans, as values of type plan. */
    default List<ChoiceRow> plans() {
        return List.of();
    }

    /** The mark by which a robot is known; the first one for a robot that is not. */
    default IdentityMark mark(String proxy) {
        return row(new ProxyValue(proxy)).mark().orElse(new IdentityMark(0));
    }

    /** The ways on which robots would go along the paths of a solution that is offered; the paths themselves where nothing is known of it. */
    default RobotWays ways(Value solution) {
        return RobotWays.AS_GIVEN;
    }

    /** The same offer, with the marks of those that are known by one, and with what is known of those of which it says nothing. */
    default Offer known(Offer offer) {
        return new Offer(offer.rows().stream().map(this::known).toList(), offer.min(), offer.max());
    }

    private ChoiceRow known(ChoiceRow row) {
        ChoiceRow known = row(row.value());
        return new ChoiceRow(
                row.value(),
                row.title(),
                row.detail().isEmpty() ? known.detail() : row.detail(),
                row.mark().or(known::mark));
    }

    /** How a value is shown in a list: as the row that is known of it, else in words. */
    default ChoiceRow row(Value value) {
        for (List<ChoiceRow> known : List.of(proxies(), tasks(), variables(), plans())) {
            for (ChoiceRow row : known) {
                if (row.value().equals(value)) {
                    return row;
                }
            }
        }
        return new ChoiceRow(value, ValueSummary.of(value), "");
    }
}
