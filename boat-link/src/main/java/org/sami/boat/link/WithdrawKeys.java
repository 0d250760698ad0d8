package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Checks.BadValueException;

/** Keys that the boat takes no longer: of a laptop that was lost. Their links end at once; paired again, a key counts again. */
public final class WithdrawKeys extends CommandMessage {
    /** Most keys in one message. */
    public static final int MOST = 1000;

    static final String TYPE = "withdraw-keys";

    private final List<String> keys;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public WithdrawKeys(String commandId, List<String> keys) {
        super(commandId);
        if (keys.size() > MOST) {
            throw new BadValueException("keys", keys.size() + " are more than " + MOST);
        }
        List<String> checked = new ArrayList<>();
        for (String key : keys) {
            checked.add(Checks.proof("keys", key));
        }
        this.keys = Collections.unmodifiableList(checked);
    }

    static WithdrawKeys read(Fields in) throws LinkException {
        List<String> keys = new ArrayList<>();
        for (JsonNode key : in.array("keys")) {
            keys.add(key.asText());
        }
        return new WithdrawKeys(in.text("command"), keys);
    }

    /** The keys' fingerprints, 64 hexadecimal digits each. */
    public List<String> keys() {
        return keys;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeArrayFieldStart("keys");
        for (String key : keys) {
            out.writeString(key);
        }
        out.writeEndArray();
    }
}
