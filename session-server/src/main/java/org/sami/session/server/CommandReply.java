package org.sami.session.server;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.session.api.Judgement;
import org.sami.session.api.LinkedBoat;
import org.sami.session.api.WayByHand;
import org.sami.session.record.LinkStatusJson;
import org.sami.spn.value.GeoPoint;

/**
 * What came of a command.
 *
 * @param text one sentence; may be empty
 * @param more further members of the message {@code done}; not to be changed
 */
record CommandReply(String text, ObjectNode more) {
    static final CommandReply DONE = of("");

    static CommandReply of(String text) {
        return new CommandReply(text, JsonNodeFactory.instance.objectNode());
    }

    /** With doubts about an answer. */
    static CommandReply of(String text, List<String> warnings) {
        CommandReply reply = of(text);
        reply.texts("warnings", warnings);
        return reply;
    }

    static CommandReply ofMission(String text, long mission) {
        CommandReply reply = of(text);
        reply.more.put("mission", mission);
        return reply;
    }

    /** With the boats that it reached. */
    static CommandReply ofBoats(List<String> boats) {
        CommandReply reply = of("");
        reply.texts("boats", boats);
        return reply;
    }

    /** With the addresses of boats, as {@code links}. */
    static CommandReply ofLinked(List<LinkedBoat> boats) {
        CommandReply reply = of("");
        ArrayNode links = reply.more.putArray("links");
        boats.forEach(one -> links.addObject()
                .put("boat", one.boat())
                .put("address", one.address().toString()));
        return reply;
    }

    /** With the links on which a vehicle is reached, as {@code links}. */
    static CommandReply ofLinkStatuses(List<LinkStatus> statuses) {
        CommandReply reply = of("");
        reply.more.set("links", LinkStatusJson.write(statuses));
        return reply;
    }

    static CommandReply of(WayByHand way) {
        CommandReply reply = of("", way.doubts());
        for (GeoPoint point : way.points()) {
            reply.more.withArray("/points").addArray().add(point.latDeg()).add(point.lonDeg());
        }
        return reply;
    }

    /** With a layer of readings. */
    static CommandReply ofLayer(ObjectNode layer) {
        CommandReply reply = of("");
        reply.more.set("layer", layer);
        return reply;
    }

    static CommandReply of(Judgement judged) {
        CommandReply reply = of("");
        for (Judgement.Remark remark : judged.remarks()) {
            reply.more
                    .withArray("/remarks")
                    .addObject()
                    .put("kind", remark.kind().name())
                    .put("words", remark.words());
        }
        return reply;
    }

    private void texts(String member, List<String> texts) {
        texts.forEach(more.withArray("/" + member)::add);
    }
}
