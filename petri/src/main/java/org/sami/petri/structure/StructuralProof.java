package org.sami.petri.structure;

import java.util.List;

/**
 * Why an answer holds in every reachable marking.
 *
 * @param method by what it was proved
 * @param words the proof for people, a line each; empty where the answer holds of every marking whatsoever
 */
public record StructuralProof(Method method, List<String> words) {
    public StructuralProof {
        words = List.copyOf(words);
    }

    /** Ways to prove. */
    public enum Method {
        /** One or more P-invariants. */
        INVARIANT("P-invariants"),
        /** The state equation with marked traps. */
        STATE_EQUATION("state equation"),
        /** Each siphon contains a marked trap. */
        SIPHON_TRAP("siphons and traps");

        private final String words;

        Method(String words) {
            this.words = words;
        }

        /** The method in words. */
        public String words() {
            return words;
        }
    }
}
