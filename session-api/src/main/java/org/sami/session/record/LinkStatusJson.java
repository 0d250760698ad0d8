package org.sami.session.record;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.proxy.gateway.LinkStatus;

/** The links on which a vehicle is reached, as a session in another process tells them (docs/session-link.md, Commands). */
public final class LinkStatusJson {
    private static final String LINK = "link";
    private static final String USED = "used";
    private static final String LOST = "lost";
    private static final String SILENT_MS = "silentMs";
    private static final String FAULT = "fault";
    private static final String SIGNAL_HERE = "signalHere";
    private static final String SIGNAL_THERE = "signalThere";
    private static final String ASKED = "askedBytesPerSecond";
    private static final String FILLED = "filledPart";

    private LinkStatusJson() {}

    /** The links, in their order; what is not known is left out. */
    public static ArrayNode write(List<LinkStatus> statuses) {
        ArrayNode links = JsonNodeFactory.instance.arrayNode();
        for (LinkStatus status : statuses) {
            ObjectNode one = links.addObject()
                    .put(LINK, status.link())
                    .put(USED, status.used())
                    .put(LOST, status.lost())
                    .put(SILENT_MS, status.silentMs())
                    .put(ASKED, status.askedBytesPerSecond());
            status.fault().ifPresent(fault -> one.put(FAULT, fault));
            status.signalHere().ifPresent(strength -> one.put(SIGNAL_HERE, strength));
            status.signalThere().ifPresent(strength -> one.put(SIGNAL_THERE, strength));
            status.filledPart().ifPresent(part -> one.put(FILLED, part));
        }
        return links;
    }

    /** The links that were written so; a member that is missing counts as not known, a number as 0. */
    public static List<LinkStatus> read(JsonNode links) {
        List<LinkStatus> statuses = new ArrayList<>();
        links.forEach(one -> statuses.add(new LinkStatus(
                one.path(LINK).asText(),
                one.path(USED).asBoolean(),
                one.path(LOST).asDouble(),
                one.path(SILENT_MS).asLong(),
                Optional.of(one.path(FAULT).asText()).filter(fault -> !fault.isEmpty()),
                number(one, SIGNAL_HERE),
                number(one, SIGNAL_THERE),
                one.path(ASKED).asDouble(),
                one.has(FILLED) ? OptionalDouble.of(one.path(FILLED).asDouble()) : OptionalDouble.empty())));
        return statuses;
    }

    private static Optional<Integer> number(JsonNode one, String member) {
        return one.has(member) ? Optional.of(one.path(member).asInt()) : Optional.empty();
    }
}
