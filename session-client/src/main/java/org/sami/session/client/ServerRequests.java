package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.concurrent.CompletionStage;

/** What is asked of the server of a session (docs/session-link.md). From any thread. */
@FunctionalInterface
interface ServerRequests {
    /** A message of a type, whose other members are to be put in. */
    static ObjectNode message(String type) {
        return JsonNodeFactory.instance.objectNode().put("t", type);
    }

    /** Asks for something; the reply arrives on the front's executor, after what followed from it. It fails where the server refuses. */
    CompletionStage<JsonNode> ask(ObjectNode message);
}
