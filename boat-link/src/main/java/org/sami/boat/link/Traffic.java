package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.Checks.BadValueException;

/**
 * The boats near the receiving boat, as the base knows them, and the no-go edges near it: what the boat needs to give way. A state and no command: it has no id
 * and no answer. Sent only to boats whose {@link Welcome} says that they take it.
 */
public final class Traffic extends LinkMessage {
    /** Most boats in one message. */
    public static final int MOST_BOATS = 64;

    static final String TYPE = "traffic";

    private static final String BOATS = "boats";
    private static final String NO_GO = "noGo";

    private final List<NearbyBoat> boats;
    private final Optional<NoGoEdges> noGo;

    /** Makes a message to a boat without no-go edges near it; too many boats are an {@link IllegalArgumentException}. */
    public Traffic(List<NearbyBoat> boats) {
        this(boats, Optional.empty());
    }

    /**
     * Makes a message; too many boats are an {@link IllegalArgumentException}.
     *
     * @param noGo the no-go edges near the receiving boat; empty where there are none
     */
    public Traffic(List<NearbyBoat> boats, Optional<NoGoEdges> noGo) {
        if (boats.size() > MOST_BOATS) {
            throw new BadValueException(BOATS, boats.size() + " are more than " + MOST_BOATS);
        }
        this.boats = Collections.unmodifiableList(new ArrayList<>(boats));
        this.noGo = Objects.requireNonNull(noGo, NO_GO);
    }

    static Traffic read(Fields in) throws LinkException {
        List<NearbyBoat> boats = new ArrayList<>();
        for (Fields row : in.objects(BOATS, MOST_BOATS)) {
            try {
                boats.add(NearbyBoat.read(row));
            } catch (BadValueException e) {
                throw row.refused(e);
            }
        }
        return new Traffic(boats, in.has(NO_GO) ? Optional.of(NoGoEdges.read(in.object(NO_GO))) : Optional.empty());
    }

    /** The boats; unmodifiable. A boat that is not listed is not near, or no longer known. */
    public List<NearbyBoat> boats() {
        return boats;
    }

    /** The no-go edges near the boat; earlier bases do not send them. */
    public Optional<NoGoEdges> noGo() {
        return noGo;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeArrayFieldStart(BOATS);
        for (NearbyBoat boat : boats) {
            boat.write(out);
        }
        out.writeEndArray();
        if (noGo.isPresent()) {
            out.writeObjectFieldStart(NO_GO);
            noGo.get().write(out);
            out.writeEndObject();
        }
    }
}
