package org.sami.crw.decision;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.protocol.Activation;

/** The activation that a question of the domain is about, as the question's subject names it: {@code m1-a4}. */
public record AskedActivation(long mission, long activation) {
    private static final Pattern SUBJECT = Pattern.compile("m(\\d{1,18})-a(\\d{1,18})");

    /** The activation, to be asked about. */
    public static AskedActivation of(Activation activation) {
        return new AskedActivation(activation.mission(), activation.id());
    }

    /** What a subject names; empty where it is about something else, such as a boat. */
    static Optional<AskedActivation> of(String subject) {
        Matcher parts = SUBJECT.matcher(subject);
        return parts.matches()
                ? Optional.of(new AskedActivation(Long.parseLong(parts.group(1)), Long.parseLong(parts.group(2))))
                : Optional.empty();
    }

    /** The question's subject. */
    public String subject() {
        return "m" + mission + "-a" + activation;
    }
}
