package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.operator.decision.PendingDecision;

/** What whoever shows a decision shows with it, as members of its row: what markups ask (appendix .2.3), and what is to be approved. */
final class DecisionMarkups {
    private DecisionMarkups() {}

    static void put(ObjectNode row, PendingDecision pending) {
        DecisionPresentation shown = pending.presentation();
        row.put("format", BoatRows.word(shown.format()));
        pending.attention()
                .ifPresent(attention -> row.putObject("attention")
                        .put("type", BoatRows.word(attention.type()))
                        .put("target", BoatRows.word(attention.target())));
        MapRelevance map = shown.map();
        map.boats().ifPresent(boats -> {
            ObjectNode show = row.putObject("show");
            Table.Builder.ids(show, "boats", boats.boats());
            show.put("paths", boats.showPath())
                    .put("state", boats.showDiagnostic())
                    .put("data", boats.showData())
                    .put("pictures", boats.showPictures());
        });
        map.area().ifPresent(area -> area(row, area));
        shown.approved().forEach(value -> Shapes.of(value).ifPresent(shape -> addShape(row, shape)));
        map.information()
                .ifPresent(information -> row.putObject("information")
                        .put("sensor", information.sensor())
                        .put("visualization", BoatRows.word(information.visualization())));
    }

    private static void area(ObjectNode row, MapRelevance.Area area) {
        Optional<ObjectNode> shape =
                area.area().map(Shapes::area).or(() -> area.point().map(Shapes::place));
        shape.ifPresent(one -> addShape(row, one));
        ObjectNode view = row.putObject("view");
        Table.Builder.ids(view, "boats", area.boats());
        area.modification().ifPresent(change -> view.put("change", BoatRows.word(change)));
    }

    private static void addShape(ObjectNode row, ObjectNode shape) {
        row.withArray("shapes").addObject().put("label", "").set("shape", shape);
    }
}
