package org.sami.session.server;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.sami.session.person.Person;
import org.sami.spn.model.Plan;

/** Messages to a front about its own person and connection: logged in, another role, removed, and the heartbeat of the session. */
final class PersonMessages {
    private PersonMessages() {}

    /**
     * Lets a person in.
     *
     * @param robots what the domain calls its robots
     */
    static ObjectNode welcome(Person person, int version, String robots, List<Plan> plans) {
        ObjectNode welcome = JsonNodeFactory.instance.objectNode();
        welcome.put("t", "welcome").put("v", version).put("name", person.name());
        role(person, welcome);
        welcome.put("robots", robots);
        ArrayNode offered = welcome.putArray("plans");
        plans.forEach(plan -> offered.addObject().put("id", plan.id()).put("title", plan.name()));
        return welcome;
    }

    /** The person's role has changed. */
    static ObjectNode rights(Person person) {
        ObjectNode rights = JsonNodeFactory.instance.objectNode().put("t", "rights");
        role(person, rights);
        return rights;
    }

    private static void role(Person person, ObjectNode message) {
        message.put("role", person.role().word());
        ArrayNode rights = message.putArray("rights");
        person.role().rights().forEach(right -> rights.add(right.word()));
    }

    /** The session is still there, at a time of its clock. */
    static ObjectNode beat(long nowMillis) {
        return JsonNodeFactory.instance.objectNode().put("t", "beat").put("now", nowMillis);
    }

    /** A person was removed. */
    static ObjectNode bye(String name) {
        return JsonNodeFactory.instance
                .objectNode()
                .put("t", "bye")
                .put("text", name + " was removed from this session");
    }
}
