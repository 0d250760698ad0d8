package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Checks.BadValueException;

/**
 * Tells the boat on which ways it comes home from the list that it holds, around what it is to avoid: for each waypoint those from anywhere on
 * the leg that leads there. The boat takes the shortest from where it is; a leg with none has no other way than the straight one. In force until
 * another list is started.
 */
public final class SetWaysHome extends CommandMessage {
    /** No message holds more turns than this. */
    public static final int MOST_TURNS = 40_000;

    static final String TYPE = "ways-home";
    private static final String NAME = "ways";

    private final String listId;
    private final List<List<List<Waypoint>>> ways;

    /**
     * Makes the message.
     *
     * @param ways for each waypoint of the list, each way as the turns before home in driving order; no turn = straight home
     * @throws IllegalArgumentException for more than {@link #MOST_TURNS} turns
     */
    public SetWaysHome(String commandId, String listId, List<List<List<Waypoint>>> ways) {
        super(commandId);
        this.listId = Checks.id("list", listId);
        List<List<List<Waypoint>>> legs = new ArrayList<>(ways.size());
        long turns = 0;
        for (List<List<Waypoint>> ofLeg : ways) {
            List<List<Waypoint>> copies = new ArrayList<>(ofLeg.size());
            for (List<Waypoint> way : ofLeg) {
                turns += way.size();
                copies.add(WaypointRows.copy(way));
            }
            legs.add(Collections.unmodifiableList(copies));
        }
        if (turns > MOST_TURNS) {
            throw new BadValueException(NAME, turns + " turns; no more than " + MOST_TURNS + " are taken");
        }
        this.ways = Collections.unmodifiableList(legs);
    }

    static SetWaysHome read(Fields in) throws LinkException {
        JsonNode legs = in.array(NAME);
        List<List<List<Waypoint>>> ways = new ArrayList<>(legs.size());
        for (int leg = 0; leg < legs.size(); leg++) {
            String where = "/" + NAME + "/" + leg;
            JsonNode ofLeg = Fields.array(legs.get(leg), where);
            List<List<Waypoint>> all = new ArrayList<>(ofLeg.size());
            for (int way = 0; way < ofLeg.size(); way++) {
                all.add(WaypointRows.read(ofLeg.get(way), where + "/" + way));
            }
            ways.add(all);
        }
        return new SetWaysHome(in.text("command"), in.text("list"), ways);
    }

    /** The list from which they lead home. */
    public String listId() {
        return listId;
    }

    /** The ways, by waypoint; unmodifiable. */
    public List<List<List<Waypoint>>> ways() {
        return ways;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("list", listId);
        out.writeArrayFieldStart(NAME);
        for (List<List<Waypoint>> ofLeg : ways) {
            out.writeStartArray();
            for (List<Waypoint> way : ofLeg) {
                WaypointRows.writeRows(out, way);
            }
            out.writeEndArray();
        }
        out.writeEndArray();
    }
}
