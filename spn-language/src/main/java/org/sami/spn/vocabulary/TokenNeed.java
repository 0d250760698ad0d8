package org.sami.spn.vocabulary;

/** What tokens an event needs to be of use (appendix .2, columns Uses Proxy and Uses Task). */
public enum TokenNeed {
    NONE,
    PROXY,
    TASK,
    PROXY_OR_TASK
}
