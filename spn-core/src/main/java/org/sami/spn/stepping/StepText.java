package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.model.TestStep;

/** A step in a few words, without values. */
public final class StepText {
    private StepText() {}

    /** The words, such as {@code press stop} or {@code ProxyPathFailed of robot-1, answering go.way}. */
    public static String of(TestStep step) {
        if (step instanceof TestStep.Answer s) {
            return "operator: " + reply(s.reply()) + (s.event().isEmpty() ? " (start)" : " to " + s.event());
        } else if (step instanceof TestStep.Occur s) {
            List<String> named = new ArrayList<>(s.proxies());
            named.addAll(s.tasks());
            String whom = named.isEmpty() ? "" : " of " + String.join(", ", named);
            return s.type() + whom + (s.answers().isEmpty() ? "" : ", answering " + s.answers());
        } else if (step instanceof TestStep.Press s) {
            return "press " + s.interrupt() + (s.proxies().isEmpty() ? "" : " for " + String.join(", ", s.proxies()));
        } else if (step instanceof TestStep.Join s) {
            return s.proxy() + " joins";
        } else if (step instanceof TestStep.Drop s) {
            return "drop " + s.proxy();
        } else if (step instanceof TestStep.Advance s) {
            return s.millis() + " ms pass";
        } else if (step instanceof TestStep.ExpectTokens s) {
            return "expect tokens in " + s.place();
        }
        return "expect the end";
    }

    private static String reply(TestStep.Reply reply) {
        if (reply instanceof TestStep.Reply.YesNo r) {
            return r.yes() ? "yes" : "no";
        } else if (reply instanceof TestStep.Reply.Proxies r) {
            return r.proxies().isEmpty() ? "nobody" : String.join(", ", r.proxies());
        } else if (reply instanceof TestStep.Reply.Option r) {
            return "option " + (r.index() + 1);
        }
        return reply instanceof TestStep.Reply.Rejected ? "none of them" : "values";
    }
}
