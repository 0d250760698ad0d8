package org.sami.crw.decision;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.decision.DecisionPresentation.LocationDefault;
import org.sami.crw.markup.MarkupReader;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * The point that the markup Default Location proposes (appendix .2.3): for the quay the project's global {@code @home}, for the area the
 * middle of the project's {@code @water}. A project without them proposes none.
 */
final class ProposedLocation {
    private static final String QUAY = "@home";
    private static final String AREA = "@water";

    private ProposedLocation() {}

    /** The decision, with the proposed point as the default of what asks for a point and has none. */
    static Decision in(Decision decision, Map<String, Value> globals) {
        Optional<GeoPoint> proposed = new MarkupReader(decision.markups())
                .constant("DefaultLocation", "location", LocationDefault.class)
                .flatMap(location -> point(location, globals));
        if (proposed.isEmpty() || !(decision.question() instanceof Question.FillIn fillIn)) {
            return decision;
        }
        List<Question.Item> items =
                fillIn.items().stream().map(item -> with(item, proposed.get())).toList();
        return decision.asking(new Question.FillIn(items));
    }

    private static Question.Item with(Question.Item item, GeoPoint proposed) {
        boolean open = item.type().equals(ValueType.Simple.POINT)
                && item.defaultValue().isEmpty();
        return open
                ? new Question.Item(
                        item.key(), item.type(), item.unit(), Optional.of(proposed), item.editable(), item.help())
                : item;
    }

    private static Optional<GeoPoint> point(LocationDefault location, Map<String, Value> globals) {
        return switch (location) {
            case QUAY -> globals.get(QUAY) instanceof GeoPoint quay ? Optional.of(quay) : Optional.empty();
            case AREA -> globals.get(AREA) instanceof GeoArea area ? Optional.of(middle(area)) : Optional.empty();
        };
    }

    /** The middle of the area's corners. */
    private static GeoPoint middle(GeoArea area) {
        List<GeoPoint> corners = area.outline();
        return GeoPoint.of(
                corners.stream().mapToDouble(GeoPoint::latDeg).average().orElseThrow(),
                corners.stream().mapToDouble(GeoPoint::lonDeg).average().orElseThrow());
    }
}
