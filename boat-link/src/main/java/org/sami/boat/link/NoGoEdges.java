package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Checks.BadValueException;

/**
 * The edges of no-go areas near a boat, and the distance that the boat keeps from them when it leaves its path to give way. Part of {@link Traffic}.
 */
public final class NoGoEdges {
    /** Most edges in one message. */
    public static final int MOST_EDGES = 64;

    private static final double MOST_KEPT_M = 10_000;
    private static final String KEEP = "keep";
    private static final String EDGES = "edges";

    private final double keepM;
    private final List<NoGoEdge> edges;

    /**
     * Edges of checked values; a value out of its range, and too many edges, are an {@link IllegalArgumentException}.
     *
     * @param keepM distance that the boat keeps from them where its path does too, in metres, from 0
     */
    public NoGoEdges(double keepM, List<NoGoEdge> edges) {
        this.keepM = Checks.range(KEEP, keepM, 0, MOST_KEPT_M);
        if (edges.size() > MOST_EDGES) {
            throw new BadValueException(EDGES, edges.size() + " are more than " + MOST_EDGES);
        }
        this.edges = Collections.unmodifiableList(new ArrayList<>(edges));
    }

    static NoGoEdges read(Fields in) throws LinkException {
        JsonNode rows = in.array(EDGES);
        List<NoGoEdge> edges = new ArrayList<>();
        for (int i = 0; i < rows.size(); i++) {
            edges.add(NoGoEdge.read(rows.get(i), in.pointer(EDGES) + "/" + i));
        }
        try {
            return new NoGoEdges(in.number(KEEP), edges);
        } catch (BadValueException e) {
            throw in.refused(e);
        }
    }

    void write(JsonGenerator out) throws IOException {
        out.writeNumberField(KEEP, keepM);
        out.writeArrayFieldStart(EDGES);
        for (NoGoEdge edge : edges) {
            edge.write(out);
        }
        out.writeEndArray();
    }

    /** Distance that the boat keeps from the edges where its path does too, in metres. */
    public double keepM() {
        return keepM;
    }

    /** The edges; unmodifiable. */
    public List<NoGoEdge> edges() {
        return edges;
    }
}
