package org.sami.spn.vocabulary;

/** What an operator is asked to do by an output event. */
public enum DecisionForm {
    /** Answer yes or no. Uses {@code accepted} for yes and {@code rejected} for no. */
    APPROVE,
    /** Choose between {@code min} and {@code max} of the proxies that entered. The answer names the chosen ones. */
    CHOOSE_PROXIES,
    /**
     * Choose one item of the list in the field {@code optionsField}, or reject them all where there is an event for that. Where the
     * field has no value, the options are the values of the variables in scope that are of the list's element type.
     */
    CHOOSE_OPTION,
    /** Give a value for every field of the answering input event. */
    PROVIDE,
    /** Give a new value for the variable named by the field {@code variable}; the engine writes it, then answers. */
    REDEFINE_VARIABLE,
    /** Give values for the variables in the list {@code variables}; the engine writes them, then answers. */
    DEFINE_VARIABLES,
    /** Choose one of the variables in scope whose type is named by the field {@code variableClass}. */
    CHOOSE_VARIABLE
}
