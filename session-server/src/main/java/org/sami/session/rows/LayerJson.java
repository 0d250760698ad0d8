package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Base64;
import java.util.OptionalDouble;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.service.field.ContourLine;
import org.sami.crw.service.field.FieldGrid;

/** A layer of readings as the link has it (docs/session-link.md, Layers of readings). */
public final class LayerJson {
    private static final int STEPS = 254; // a cell is a byte: 0 nothing, 1 the least value, 255 the greatest
    private static final int MOST_SEGMENTS = 2000; // of all contours

    private LayerJson() {}

    /** The layer's members. */
    public static ObjectNode of(SensorLayer layer) {
        FieldGrid grid = layer.grid();
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        json.put("sensor", layer.channel().sensor())
                .put("channel", layer.channel().channel());
        Table.Builder.put(json, "unit", layer.channel().unit());
        json.put("visualization", BoatRows.word(layer.visualization()))
                .put("least", grid.least())
                .put("greatest", grid.greatest())
                .put("south", Shapes.rounded(grid.southWest().latDeg()))
                .put("west", Shapes.rounded(grid.southWest().lonDeg()))
                .put("north", Shapes.rounded(grid.southWest().latDeg() + grid.rows() * grid.latStepDeg()))
                .put("east", Shapes.rounded(grid.southWest().lonDeg() + grid.columns() * grid.lonStepDeg()))
                .put("columns", grid.columns())
                .put("cells", Base64.getEncoder().encodeToString(cells(layer)));
        layer.legend().marks().forEach(json.putArray("marks")::add);
        if (!layer.contours().isEmpty()) {
            contours(json.putArray("contours"), layer);
        }
        return json;
    }

    /** Row by row from the north-west; cells that are not drawn are 0. */
    private static byte[] cells(SensorLayer layer) {
        FieldGrid grid = layer.grid();
        double range = grid.greatest() - grid.least();
        byte[] cells = new byte[grid.columns() * grid.rows()];
        int at = 0;
        for (int row = grid.rows() - 1; row >= 0; row--) {
            for (int column = 0; column < grid.columns(); column++) {
                OptionalDouble value = grid.value(column, row);
                if (value.isPresent() && layer.isDrawn(column, row)) {
                    double part = range > 0 ? (value.getAsDouble() - grid.least()) / range : 0.5;
                    cells[at] = (byte) (1 + Math.round(part * STEPS));
                }
                at++;
            }
        }
        return cells;
    }

    private static void contours(ArrayNode contours, SensorLayer layer) {
        int left = MOST_SEGMENTS;
        for (ContourLine line : layer.contours()) {
            ObjectNode one = contours.addObject().put("value", line.value());
            ArrayNode segments = one.putArray("segments");
            for (ContourLine.Segment segment :
                    line.segments().subList(0, Math.min(left, line.segments().size()))) {
                segments.addArray().add(Shapes.point(segment.from())).add(Shapes.point(segment.to()));
            }
            left -= segments.size();
        }
    }
}
