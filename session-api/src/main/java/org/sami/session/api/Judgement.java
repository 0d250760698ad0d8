package org.sami.session.api;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.fleet.RobotKind;

/**
 * What is to be said of an answer before it is given. Immutable.
 *
 * @param remarks the worst first
 */
public record Judgement(List<Remark> remarks) {
    /** Nothing is to be said. */
    public static final Judgement NOTHING = new Judgement(List.of());

    /** How much a remark weighs. */
    public enum Kind {
        /** The answer makes no sense, and is refused. */
        REFUSAL,
        /** The operator is asked whether it is meant so. */
        DOUBT,
        /** What it takes. */
        COST
    }

    /**
     * One thing to be said.
     *
     * @param words a sentence without its full stop
     */
    public record Remark(Kind kind, String words) {
        public Remark {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(words, "words");
        }

        /** Why the answer is refused. */
        public static Remark refusal(String words) {
            return new Remark(Kind.REFUSAL, words);
        }

        /** What the operator is asked. */
        public static Remark doubt(String words) {
            return new Remark(Kind.DOUBT, words);
        }

        /** What it takes. */
        public static Remark cost(String words) {
            return new Remark(Kind.COST, words);
        }
    }

    public Judgement {
        remarks = List.copyOf(remarks);
    }

    /** The same in words about robots of a kind. */
    public Judgement inWordsFor(RobotKind robots) {
        return new Judgement(remarks.stream()
                .map(remark -> new Remark(remark.kind(), robots.say(remark.words())))
                .toList());
    }

    /** Each remark once, the worst first. */
    public static Judgement of(List<Remark> remarks) {
        return new Judgement(remarks.stream()
                .distinct()
                .sorted((one, other) -> one.kind().compareTo(other.kind()))
                .toList());
    }

    /** Why the answer is refused; empty where it is not. */
    public Optional<String> refusal() {
        return words(Kind.REFUSAL).stream().findFirst();
    }

    /** What the operator is asked. */
    public List<String> doubts() {
        return words(Kind.DOUBT);
    }

    /** What it takes. */
    public List<String> costs() {
        return words(Kind.COST);
    }

    private List<String> words(Kind kind) {
        return remarks.stream()
                .filter(remark -> remark.kind() == kind)
                .map(Remark::words)
                .toList();
    }
}
